# The package for Debian and its relatives; app/package makes it.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SECTION education)
# The libraries it is linked with, and their versions, are found by dpkg-shlibdeps. Qt's
# plugins for screen and pictures are in the packages of those libraries.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Qt's own texts; without them they are English.
set(CPACK_DEBIAN_PACKAGE_DEPENDS qt6-translations-l10n)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Weights hang on ropes and swing. All ropes are cut. The weights fly, bounce,
hit each other and come to rest. Up to four numerical methods compute the same
scene side by side, so that a class sees where they part, and an energy ledger
says how much each method itself got wrong.
.
Scenes run without a window, too, and give CSV files and charts.")
