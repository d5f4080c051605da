# Makes Python find the package robcogen without PYTHONPATH: a file robcogen.pth, which leads from the folder where Python
# looks for packages to share/robcogen/python. The prefix may be that of a Python (/usr, /usr/local) or a virtual
# environment; in any other prefix, Python looks nowhere, and `pip install <prefix>/share/robcogen/python` serves.
find_package(Python3 3.11 QUIET COMPONENTS Interpreter)
if(Python3_VERSION_MAJOR)
  set(ROBCOGEN_PYTHON_VERSION ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR})
endif()
set(ROBCOGEN_PYTHON_VERSION "${ROBCOGEN_PYTHON_VERSION}" CACHE STRING "The Python, such as 3.11, that finds the installed package robcogen")
mark_as_advanced(ROBCOGEN_PYTHON_VERSION)
if(ROBCOGEN_PYTHON_VERSION)
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/python/robcogen.pth "../../../share/robcogen/python\n")
  install(
    CODE "
    set(folder lib/python${ROBCOGEN_PYTHON_VERSION}/site-packages)
    # Debian's own Python has other folders.
    if(EXISTS /etc/debian_version AND \"\${CMAKE_INSTALL_PREFIX}\" STREQUAL /usr)
      set(folder lib/python3/dist-packages)
    elseif(EXISTS /etc/debian_version AND \"\${CMAKE_INSTALL_PREFIX}\" STREQUAL /usr/local)
      set(folder lib/python${ROBCOGEN_PYTHON_VERSION}/dist-packages)
    endif()
    file(INSTALL \"${CMAKE_CURRENT_BINARY_DIR}/python/robcogen.pth\" DESTINATION \"\${CMAKE_INSTALL_PREFIX}/\${folder}\")")
endif()
