# Writes OUTPUT, a header with the commit that SOURCE has been built from: the
# last one that changed the program, with a "+" if its files have changed since.
# Empty outside of a git repository. Left alone if it is right already.
find_package(Git QUIET)
set(program_files -- source include CMakeLists.txt)
set(commit "")
if(GIT_FOUND AND EXISTS ${SOURCE}/.git)
  execute_process(COMMAND ${GIT_EXECUTABLE} log -1 --format=%h --abbrev=9 ${program_files}
                  WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${GIT_EXECUTABLE} status --porcelain ${program_files}
                  WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE changes ERROR_QUIET)
  if(commit AND changes)
    string(APPEND commit "+")
  endif()
endif()
set(text "#define STICKSLIP_SOURCE_COMMIT \"${commit}\"\n")
set(present "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} present)
endif()
if(NOT present STREQUAL text)
  file(WRITE ${OUTPUT} "${text}")
endif()
