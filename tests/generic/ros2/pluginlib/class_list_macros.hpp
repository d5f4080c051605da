// The class is known to the test by its name.
#pragma once

#include <type_traits>

#define PLUGINLIB_EXPORT_CLASS(Class, Base) static_assert(std::is_base_of_v<Base, Class>);
