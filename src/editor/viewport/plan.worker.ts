import { servePlans } from '../../render/refine/planServer.ts';

/** Plans pictures off the main thread. */
servePlans(self);
