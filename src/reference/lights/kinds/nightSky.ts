import type { NightSky } from '../../../scene/types.ts';
import type { LightTracer } from './lightTracer.ts';

/** Stars light nothing, and are seen as points of the picture (starField.ts). */
export const NIGHT_SKY: LightTracer<NightSky> = { trace: () => ({}) };
