#!/bin/sh
#SBATCH --job-name=umbra-shares
#SBATCH --array=1-16
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=8
#SBATCH --time=02:00:00
# A study by sixteen jobs, each of which computes every sixteenth point; then one that writes the results.
#   shares=$(sbatch --parsable examples/slurm/array.sh study.yaml out/study)
#   sbatch --dependency=afterok:"$shares" --wrap "umbra study study.yaml --out out/study --resume"
study=$1
out=$2
exec umbra study "$study" --out "$out" --resume --workers "$SLURM_CPUS_PER_TASK" \
  --share "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT"
