# Wrong calls; ../calls.cmake says how they are read.

#### install_keyword_without_value
# robcogen_install_robots(): missing value: PACKAGE
robcogen_install_robots(TARGETS hyl PACKAGE)

#### install_no_such_target
# robcogen_install_robots(): TARGETS: unknown target 'arm'
robcogen_install_robots(TARGETS arm)

#### install_no_targets
# robcogen_install_robots(): TARGETS is missing
robcogen_install_robots(PACKAGE arms)

#### install_off
# robcogen_install_robots(): unknown argument 'OFF'; the keywords are TARGETS PACKAGE
robcogen_install_robots(OFF)

#### install_package_twice
# robcogen_install_robots(): PACKAGE is given 2 times; it has one value
robcogen_install_robots(TARGETS hyl PACKAGE arms PACKAGE legs)

#### install_positional
# robcogen_install_robots(): unknown argument 'hyl'; the keywords are TARGETS PACKAGE
robcogen_install_robots(hyl)
