# All of these are Debian 12 packages; app/packages.txt names them.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(tl-expected REQUIRED)
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(EXPAT REQUIRED)
find_package(GDAL REQUIRED)
find_package(OpenCV REQUIRED COMPONENTS core imgproc imgcodecs)
find_package(SQLite3 REQUIRED)
find_package(nlohmann_json REQUIRED)

find_package(PkgConfig REQUIRED)
pkg_check_modules(GeographicLib REQUIRED IMPORTED_TARGET geographiclib)
pkg_check_modules(Geos REQUIRED IMPORTED_TARGET geos)
pkg_check_modules(TomlPlusPlus REQUIRED IMPORTED_TARGET tomlplusplus)
pkg_check_modules(Zstd REQUIRED IMPORTED_TARGET libzstd)
# PCL's own CMake files look for VTK and every optional driver; the three libraries that we use need none of that.
pkg_check_modules(PclCommon REQUIRED IMPORTED_TARGET pcl_common)
set(NADIR_PCL_LIBRARIES PkgConfig::PclCommon pcl_io pcl_filters)
