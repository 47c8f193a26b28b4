import type { NightSky } from '../../../scene/types.ts';
import type { LightTracer } from './lightTracer.ts';

/** Stars do not light surfaces; they are drawn as points of the picture (starField.ts). */
export const NIGHT_SKY: LightTracer<NightSky> = { trace: () => ({}) };
