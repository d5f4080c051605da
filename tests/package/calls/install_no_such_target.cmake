# robcogen_install_robots(): TARGETS: there is no target 'arm'
robcogen_install_robots(TARGETS arm)
