#pragma once

#include "deadpoint/error.hpp"  // public
