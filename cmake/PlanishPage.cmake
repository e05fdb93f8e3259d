# Run as a script: installs what the studio's page is built with, or builds the page, where that has not
# been done since its files changed. Build trees share web/, and one that is built while another is
# used must not take the page away.
#
#   cmake -D STEP=install|build -D WEB=<web> -D NPM=<npm> -P PlanishPage.cmake

set(stamp "${WEB}/node_modules/.planish-installed")
if(STEP STREQUAL "install")
  set(made "${stamp}")
  set(sources "${WEB}/package.json" "${WEB}/package-lock.json")
  set(command ci --no-audit --no-fund --prefer-offline)
else()
  set(made "${WEB}/dist/index.html")
  file(GLOB_RECURSE sources "${WEB}/src/*" "${WEB}/public/*")
  # Its types are written from the schemas.
  file(GLOB settings "${WEB}/*.html" "${WEB}/*.ts" "${WEB}/*.js" "${WEB}/*.json" "${WEB}/tools/*"
    "${WEB}/../docs/schema/*.json")
  list(APPEND sources ${settings} "${stamp}")
  set(command run build)
endif()

set(current ON)
foreach(source IN LISTS sources)
  # True also where `made` is missing, or both are of the same moment.
  if("${source}" IS_NEWER_THAN "${made}")
    set(current OFF)
  endif()
endforeach()
if(current)
  return()
endif()
execute_process(COMMAND "${NPM}" ${command} WORKING_DIRECTORY "${WEB}" COMMAND_ERROR_IS_FATAL ANY)
if(STEP STREQUAL "install")
  file(TOUCH "${stamp}")
endif()
