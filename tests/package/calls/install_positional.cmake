# robcogen_install_robots(): unknown argument 'hyl'; the keywords are TARGETS PACKAGE
robcogen_install_robots(hyl)
