// Balls as camera-facing squares that a ray meets as exact spheres: four corners or one point for each, whatever its
// size on screen. Positions come as 16-bit values of two neighbouring frames.

/// Where a body is between two frames, and how it is turned.
export const motion = /* glsl */ `
uniform mat4 modelViewMatrix, projectionMatrix, viewMatrix;
uniform vec3 boxFrom, boxSize, period;  // period: of space, in units of the box; 0: it does not repeat
uniform float mixing;
in vec3 place0, place1;
#ifdef TURNS
in vec3 turn0, turn1;
#endif

/// Nobody is where all three values are the last.
bool nobody(vec3 stored) {
  return all(greaterThanEqual(stored, vec3(1.0)));
}

vec3 place() {
  if (nobody(place0)) return boxFrom + boxSize * place1;
  if (nobody(place1)) return boxFrom + boxSize * place0;
  vec3 way = place1 - place0;
  way -= period * floor(way / max(period, 1e-6) + 0.5);
  return boxFrom + boxSize * (place0 + mixing * way);
}

#ifdef TURNS
vec4 quaternion(vec3 stored) {
  vec3 xyz = stored * 2.0 - 1.0;
  return vec4(xyz, sqrt(max(0.0, 1.0 - dot(xyz, xyz))));
}

vec4 turned() {
  vec4 a = quaternion(turn0), b = quaternion(turn1);
  return normalize(mix(a, dot(a, b) < 0.0 ? -b : b, mixing));
}
#endif
`;

export const ballVertex = /* glsl */ `
precision highp float;
${motion}
#ifdef CORNERS
in vec3 position;
#endif
in float radius;
in vec4 tint;  // alpha: has it a pattern?
in float value0, value1;
uniform float valueMixing, useMap, pointPixels, leastPixels, room;
uniform vec2 mapRange, screen;
uniform sampler2D map;
flat out vec4 ball;  // its centre, seen from the eye, and radius
flat out uint paint;  // its colour, and has it a pattern?
#ifdef TURNS
flat out vec4 turn;
#endif

#ifdef CORNERS
/// Where a sphere's edges are seen along one axis: x / depth of the two tangents from the eye.
vec2 edges(float x, float depth, float r) {
  float t = sqrt(x * x + depth * depth - r * r);
  return vec2((x * t - depth * r) / (depth * t + x * r), (x * t + depth * r) / (depth * t - x * r));
}
#endif

void main() {
  vec3 centre = (modelViewMatrix * vec4(place(), 1.0)).xyz;
  float depth = -centre.z;
  vec2 zoom = vec2(projectionMatrix[0][0], projectionMatrix[1][1]);
  float perPixel = depth / (0.5 * screen.y * zoom.y);
  float size = radius > 0.0 ? max(radius, leastPixels * perPixel) : pointPixels * perPixel;
  ball = vec4(centre, size);
  float pixels = size / perPixel;
  float value = (mix(value0, value1, valueMixing) - mapRange.x) / (mapRange.y - mapRange.x);
  vec3 colour = useMap > 0.5 ? texelFetch(map, ivec2(clamp(value * 256.0, 0.0, 255.0), 0), 0).rgb : tint.rgb;
  uvec4 bytes = uvec4(vec4(colour, radius > 0.0 ? tint.a : 0.0) * 255.0 + 0.5);
  paint = bytes.r | bytes.g << 8 | bytes.b << 16 | bytes.a << 24;
#ifdef TURNS
  turn = turned();
#endif
  float far = (projectionMatrix[2][2] * centre.z + projectionMatrix[3][2]) / depth;
#ifdef CORNERS
  vec2 x = edges(centre.x, depth, size) * zoom.x, y = edges(centre.y, depth, size) * zoom.y;
  vec2 middle = 0.5 * vec2(x.x + x.y, y.x + y.y);
  vec2 extent = 0.5 * vec2(x.y - x.x, y.y - y.x) + room / screen;
  gl_Position = vec4(middle + position.xy * extent, far, 1.0);
#else
  // A square around the middle that holds the ellipse, if the ball is not close to the eye.
  gl_PointSize = 2.0 * pixels / (1.0 - size / depth) * (1.0 + dot(centre.xy, centre.xy) / (2.0 * depth * depth));
  gl_Position = vec4(zoom * centre.xy / depth, far, 1.0);
#endif
  // the eye is inside it, or before it; or nobody is there
  if (depth < 1.001 * size || nobody(mixing < 0.5 ? place0 : place1)) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
`;

export const ballFragment = /* glsl */ `
precision highp float;
uniform mat4 projectionMatrix, viewMatrix;
uniform vec2 screen, corner;  // of this view on the canvas, in pixels
uniform float stripes, ambient;
flat in vec4 ball;
flat in uint paint;
#ifdef TURNS
flat in vec4 turn;
#endif
out vec4 seen;

const vec3 lamp = vec3(-0.40, 0.55, 0.73), halfway = vec3(-0.2135, 0.2936, 0.9318);  // between the lamp and the eye

vec3 turnedBack(vec3 v, vec4 q) { return v + 2.0 * cross(cross(v, q.xyz) + q.w * v, q.xyz); }

/// The pattern of a ball that turns, as in stills: a white band about the z axis of the body, half a dark one across.
vec3 striped(vec3 base, vec3 n, float pixels) {
  float soft = 0.7 / pixels;
  float band = 1.0 - smoothstep(0.22 - soft, 0.22 + soft, abs(n.z));
  float across = (1.0 - smoothstep(0.09 - soft, 0.09 + soft, abs(n.x))) * smoothstep(-soft, soft, n.y);
  return mix(base, mix(mix(base, vec3(0.97), band), vec3(0.14), across), smoothstep(2.5, 5.0, pixels));
}

void main() {
  // Few values come from the vertex: setting them up for each ball is what takes the time of a large crowd.
  vec3 centre = ball.xyz, colour = vec3(paint & 255u, paint >> 8 & 255u, paint >> 16 & 255u) / 255.0;
  float size = ball.w, pixels = size * 0.5 * screen.y * projectionMatrix[1][1] / -centre.z;
  vec2 place = (gl_FragCoord.xy - corner) / screen * 2.0 - 1.0;
  vec3 ray = vec3(place / vec2(projectionMatrix[0][0], projectionMatrix[1][1]), -1.0);
  float perLength2 = 1.0 / dot(ray, ray), along = dot(ray, centre) * perLength2;
  vec3 beside = ray * along - centre;  // of the ray's nearest point to the centre: no difference of large squares
  float inside = size * size - dot(beside, beside);
#ifdef SMOOTH
  float cover = clamp((1.0 - length(beside) / size) * pixels + 0.5, 0.0, 1.0);
  if (cover <= 0.0) discard;
#else
  float cover = 1.0;
  if (inside < 0.0) discard;
#endif
  if (pixels < 2.0) {  // too small for more than its colour; most bodies of a large crowd are
    gl_FragDepth = 0.5 - 0.5 * (projectionMatrix[2][2] + projectionMatrix[3][2] / centre.z);
    seen = vec4(colour * (0.8 + 0.2 * inside / (size * size)), cover);
    return;
  }
  vec3 met = ray * (along - sqrt(max(inside, 0.0) * perLength2));
  vec3 normal = (met - centre) * (1.0 / size);
  gl_FragDepth = 0.5 - 0.5 * (projectionMatrix[2][2] + projectionMatrix[3][2] / met.z);

#ifdef TURNS
  if (stripes > 0.5 && paint >> 24 != 0u) {
    colour = striped(colour, turnedBack(transpose(mat3(viewMatrix)) * normal, turn), pixels);
  }
#endif
  float sky = 0.5 + 0.5 * dot(normal, viewMatrix[2].xyz);
  float lit = max(dot(normal, lamp), 0.0);
  float shine = max(dot(normal, halfway), 0.0);
  for (int i = 0; i < 6; ++i) shine *= shine;  // to the power of 64
  float shade = mix(0.9, ambient + 0.16 * sky + (0.92 - ambient) * lit, clamp(0.5 * pixels - 1.0, 0.0, 1.0));
  seen = vec4(colour * shade + 0.16 * shine * clamp(0.2 * pixels - 0.6, 0.0, 1.0), cover);
}
`;
