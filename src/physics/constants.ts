/** c of a vacuum [m/s], exact by the definition of the metre (SI, 2019). */
export const SPEED_OF_LIGHT = 299_792_458;
