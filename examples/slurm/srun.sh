#!/bin/sh
#SBATCH --job-name=umbra-study
#SBATCH --nodes=4
#SBATCH --ntasks-per-node=1
#SBATCH --cpus-per-task=32
#SBATCH --time=04:00:00
#SBATCH --requeue
# A study on four nodes, 32 worker processes each. Submit it again after a time limit: it resumes.
#   sbatch examples/slurm/srun.sh study.yaml out/study
study=$1
out=$2
# what srun must speak is what this cluster's MPI was built with: srun --mpi=list
exec srun --mpi=pmix --kill-on-bad-exit=1 --cpu-bind=none \
  umbra study "$study" --out "$out" --resume --workers "$SLURM_CPUS_PER_TASK"
