// A small scene, and its frames in a file.
#pragma once

#include <memory>
#include <string>

#include "ballpark/scene.h"
#include "ballpark/world.h"
#include "scenarios/command/frame_file.h"

inline constexpr double falling_step = 1.0 / 64;

/// Two points, and two dice if they are wanted.
inline ballpark::Scene falling(bool tumbling) {
  ballpark::Scene scene;
  scene.name = "falling";
  scene.run.duration = 1;
  scene.run.step = falling_step;
  ballpark::BodyGroup points;
  points.name = "points";
  points.mass = {2};
  points.position = {{0, 0, 1.0 / 3}, {1, 2, 3}};
  points.velocity = {{0.1, 0.2, 0.3}};
  scene.bodies = {points};
  if (tumbling) {
    ballpark::BodyGroup dice = points;
    dice.name = "dice";
    dice.inertia = {{1, 2, 2.5}};
    dice.angular_velocity = {{1, 2, 3}};
    dice.radius = {0.5, 0.25};
    scene.bodies.push_back(dice);
  }
  scene.effects = {{"gravity", {}, {}}};
  return scene;
}

inline ballpark::scenes::OutputRequest request_of(const std::string& path) {
  ballpark::scenes::OutputRequest request;
  request.file = path;
  return request;
}

/// Frames in a file, without a thread.
struct Filming {
  std::unique_ptr<ballpark::command::FrameFile> file;
  ballpark::command::FrameReader reader;
  ballpark::command::Frames frames;

  Filming(const ballpark::scenes::OutputRequest& request, const ballpark::Scene& scene, const ballpark::World& world)
      : file(ballpark::command::open_frame_file(request, scene)), reader(world, scene, request) {
    file->begin(reader.layout());
  }
  void add(const ballpark::World& world) {
    frames.clear();
    reader.add(world, frames);
    file->add(frames);
  }
};
