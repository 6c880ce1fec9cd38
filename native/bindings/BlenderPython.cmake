# Finds the Python that Blender runs, and the same version's interpreter and headers on this machine:
# whichever python3 stands first on PATH may be another one, and its module would not load.
#
# Sets Python_EXECUTABLE (unless given) and MESHKNIT_BLENDER_SOABI, both cached.
set(MESHKNIT_BLENDER "blender" CACHE STRING "The Blender that the module is for")

if(NOT MESHKNIT_BLENDER_SOABI)
  execute_process(
    COMMAND ${MESHKNIT_BLENDER} --background --factory-startup --python-expr
      "import sys, sysconfig; print('MESHKNIT', sys.version_info[0], sys.version_info[1], sysconfig.get_config_var('SOABI'))"
    OUTPUT_VARIABLE _said ERROR_QUIET RESULT_VARIABLE _failed)
  if(NOT _said MATCHES "MESHKNIT ([0-9]+) ([0-9]+) ([^\n]+)")
    message(FATAL_ERROR "Could not ask ${MESHKNIT_BLENDER} for its Python. Install Blender or pass "
      "-DMESHKNIT_BLENDER=/path/to/blender.")
  endif()
  set(_version "${CMAKE_MATCH_1}.${CMAKE_MATCH_2}")
  set(MESHKNIT_BLENDER_SOABI "${CMAKE_MATCH_3}" CACHE STRING "SOABI of the Python inside Blender")
  if(NOT Python_EXECUTABLE)
    find_program(_python "python${_version}" PATHS /usr/bin /usr/local/bin NO_DEFAULT_PATH)
    if(NOT _python)
      message(FATAL_ERROR "Blender runs Python ${_version}: install its headers (python${_version}-dev) "
        "or pass -DPython_EXECUTABLE=...")
    endif()
    set(Python_EXECUTABLE "${_python}" CACHE FILEPATH "Interpreter of Blender's Python version")
  endif()
endif()
