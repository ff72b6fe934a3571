#pragma once

#include "deadpoint/observer.hpp"  // public
