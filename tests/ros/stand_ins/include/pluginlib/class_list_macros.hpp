// Stand-in for pluginlib: the library has a function that makes an object of its class.
#pragma once

#define PLUGINLIB_EXPORT_CLASS(Class, Base)                                \
  extern "C" __attribute__((visibility("default"))) Base* create_plugin(); \
  extern "C" Base* create_plugin() {                                       \
    return new Class;                                                      \
  }
