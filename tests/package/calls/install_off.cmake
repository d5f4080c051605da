# robcogen_install_robots(): unknown argument 'OFF'; the keywords are TARGETS PACKAGE
robcogen_install_robots(OFF)
