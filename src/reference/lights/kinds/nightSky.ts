import type { NightSky } from '../../../scene/types.ts';
import type { LightTracer } from './lightTracer.ts';

/** Stars are drawn as points of the picture (starField.ts); what they shine on is lit by a dome (scene/stars/starDome.ts). */
export const NIGHT_SKY: LightTracer<NightSky> = { trace: () => ({}) };
