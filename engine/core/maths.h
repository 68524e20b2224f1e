// Elementary functions whose bits depend on nothing but the argument: not on compiler, optimisation, instruction set or
// flush-to-zero, all of which change what platform libms return. For all code that shapes a result.
//
// Accuracy: below 0.6 ulp over the whole range, denormals included (tested against MPFR). Special values are those of C
// (Annex F): sin(inf), log(-1), acos(2), pow(-8, 1/3.) are NaN, log(0) = -inf, pow(x, 0) = pow(1, y) = 1, and zeros
// keep their sign. Every NaN returned is one and the same quiet NaN. errno and the exception flags mean nothing. The
// long double overloads forward to the platform: they serve reference solutions, and promise no bits.
#pragma once

namespace ballpark::maths {

float sin(float x);
double sin(double x);
long double sin(long double x);

float cos(float x);
double cos(double x);
long double cos(long double x);

float exp(float x);
double exp(double x);
long double exp(long double x);

float log(float x);
double log(double x);
long double log(long double x);

float pow(float x, float y);
double pow(double x, double y);
long double pow(long double x, long double y);

float cbrt(float x);
double cbrt(double x);
long double cbrt(long double x);

float acos(float x);
double acos(double x);
long double acos(long double x);

float atan2(float y, float x);
double atan2(double y, double x);
long double atan2(long double y, long double x);

}  // namespace ballpark::maths
