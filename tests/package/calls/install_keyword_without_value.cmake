# robcogen_install_robots(): missing value: PACKAGE
robcogen_install_robots(TARGETS hyl PACKAGE)
