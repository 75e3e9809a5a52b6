#!/bin/sh
#SBATCH --job-name=oncard-explore
#SBATCH --cpus-per-task=1
# Explores one part of a search; submitted as a job array with a task for every part:
#
#   sbatch --array=1-64 explore_slurm.sh INPUT [OPTIONS OF oncard explore]
#
# Each part is kept in NAME.I-of-64.search in the folder of the submission. It is saved every minute
# and when the time limit ends it. If submitted again, it continues the parts that are not complete.
# After the last one has ended:
#
#   oncard explore --merge NAME.*-of-64.search
set -u

input=$1
shift

oncard explore "$input" --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_MAX" "$@"
code=$?
# Proved, failed, or passed within its bound: the task is complete. At a limit it is not.
case $code in
  0 | 1 | 5) exit 0 ;;
  *) exit "$code" ;;
esac
