# robcogen_install_robots(): TARGETS: unknown target 'arm'
robcogen_install_robots(TARGETS arm)
