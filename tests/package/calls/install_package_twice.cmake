# robcogen_install_robots(): PACKAGE is given 2 times; it has one value
robcogen_install_robots(TARGETS hyl PACKAGE arms PACKAGE legs)
