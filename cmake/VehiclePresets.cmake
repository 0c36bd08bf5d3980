# The vehicle presets of assets/vehicles become part of a library, so that they need no files at run
# time.
function(hedr_embed_vehicle_presets target)
  set(HEDR_VEHICLE_PRESETS "")
  foreach(name packbot labmate romi)
    set(file ${PROJECT_SOURCE_DIR}/assets/vehicles/${name}.toml)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    string(APPEND HEDR_VEHICLE_PRESETS "    R\"toml(${text})toml\",\n")
  endforeach()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/vehicle_presets.cpp)
  configure_file(${PROJECT_SOURCE_DIR}/core/robot/vehicle_presets.cpp.in ${source} @ONLY)
  target_sources(${target} PRIVATE ${source})
endfunction()
