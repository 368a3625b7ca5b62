// Headers that nearly every test sees, compiled once. Nobody includes this file.
#pragma once

#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <numbers>

#include "common/precompiled.hpp"
