/* Private to base/batch/: what the launcher of several processes has told this one. */
#ifndef UMBRA_BATCH_LAUNCH_IMPL_H
#define UMBRA_BATCH_LAUNCH_IMPL_H

/* The number of this process and how many there are; -1: nothing is told. The environment is read
 * at the first call, which comes before MPI_Init: that writes there, too. Does not fail. */
void um_batch_launch_told(long *rank, long *size);
/* PMIx's place without the address of who leads is taken from the environment: OpenMPI 5 ends the
 * process over it. Before MPI_Init, behind the call above. */
void um_batch_launch_forget_stray(void);

#endif
