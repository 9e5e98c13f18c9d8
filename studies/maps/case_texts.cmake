# The cases that maps vary, as a header: an installed plenum-study needs no folder of cases.
set(caseTexts "")
foreach(case gas_box pairing_3d hydrostatic_tank rotating_shaft dam_break_multiphase
        stability/two_layers)
  set(file ${PROJECT_SOURCE_DIR}/cases/${case}.toml)
  file(READ ${file} text)
  get_filename_component(name ${case} NAME)
  string(APPEND caseTexts "    {\"${name}\", R\"CASE(${text})CASE\"},\n")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
endforeach()
configure_file(maps/case_texts.hpp.in ${CMAKE_CURRENT_BINARY_DIR}/generated/studies/maps/case_texts.hpp @ONLY)
target_include_directories(plenum_studies PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/generated)
