// All of Ballpark's public face.
#pragma once

#include "ballpark/catalogue.h"
#include "ballpark/options.h"
#include "ballpark/report.h"
#include "ballpark/scene.h"
#include "ballpark/state.h"
#include "ballpark/user_effect.h"
#include "ballpark/watch.h"
#include "ballpark/world.h"
