include(GNUInstallDirs)
install(TARGETS hedr hedr-ocu RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY assets/vehicles assets/sample_building
        DESTINATION ${CMAKE_INSTALL_DATADIR}/hedr)
