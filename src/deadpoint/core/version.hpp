#pragma once

#include "deadpoint/version.hpp"  // public
