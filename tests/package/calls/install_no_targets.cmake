# robcogen_install_robots(): TARGETS is missing
robcogen_install_robots(PACKAGE arms)
