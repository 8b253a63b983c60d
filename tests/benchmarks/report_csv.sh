#!/usr/bin/env bash
# A few columns of `nadir evaluate --csv`, as a Markdown table: bash tests/benchmarks/report_csv.sh NADIR RUN...
set -euo pipefail
nadir=$1
shift
"$nadir" evaluate "$@" --csv --quiet | awk -F, '
  NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next_header(); next }
  function next_header() {
    print "| run | preset | seed | odometry RMSE m | estimate RMSE m | mean m | median m | max m | yaw MSE rad^2 | NEES | in 95 % |"
    print "|---|---|---|---|---|---|---|---|---|---|---|"
  }
  function value(name) { return $column[name] }
  function name(path) { sub(".*/", "", path); sub("[.]nadir$", "", path); return path }
  { printf "| %s | %s | %s | %.2f | %.2f | %.2f | %.2f | %.2f | %.5f | %.2f | %.3f |\n", name(value("run")), value("preset"), value("seed"),
      value("odometry_position_rmse_m"), value("estimate_position_rmse_m"), value("estimate_position_mean_m"),
      value("estimate_position_median_m"), value("estimate_position_max_m"), value("estimate_orientation_mse_rad2"),
      value("nees_mean"), value("coverage_95") }'
