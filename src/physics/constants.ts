/** c of a vacuum [m/s], exact by the definition of the metre (SI, 2019). */
export const SPEED_OF_LIGHT = 299_792_458;
/** Standard gravity, 1 g [m/s²], exact by definition (CGPM, 1901). */
export const STANDARD_GRAVITY = 9.80665;
