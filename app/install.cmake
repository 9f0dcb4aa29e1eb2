# SPDX-FileCopyrightText: 2026 the Stratascope authors
# SPDX-License-Identifier: BSD-3-Clause
# What a desktop needs beside the programs, and the Debian package (cpack -G DEB).
set(desktop ${CMAKE_SOURCE_DIR}/resources/desktop)
install(FILES ${desktop}/stratascope-cli.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/resources/presets DESTINATION ${CMAKE_INSTALL_DATADIR}/stratascope)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/resources/help/ DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${CMAKE_SOURCE_DIR}/sample_scans/stair_hall.pcd ${CMAKE_SOURCE_DIR}/sample_scans/pipe_corridor.pcd
  DESTINATION ${CMAKE_INSTALL_DATADIR}/stratascope/samples)
install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
if(STRATASCOPE_WINDOW)
  install(FILES ${desktop}/stratascope.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  install(FILES ${desktop}/stratascope-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME stratascope.xml)
  install(FILES ${desktop}/io.github.stratascope.Stratascope.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
  install(FILES ${desktop}/stratascope.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${CMAKE_SOURCE_DIR}/resources/icons/stratascope.svg
    DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
endif()

set(CPACK_PACKAGE_NAME stratascope)
set(CPACK_PACKAGE_VENDOR "the Stratascope authors")
set(CPACK_PACKAGE_CONTACT "the Stratascope authors <stratascope@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Maps from scans of a rotating laser scanner")
set(CPACK_PACKAGE_DESCRIPTION "Turns 3D scans of a rotating 2D laser scanner into 2.5D and extended 2.5D maps through a cellular
neural network, in a window or on the command line.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # dependencies from what the programs are linked with
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
include(CPack)
