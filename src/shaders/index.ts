/**
 * The formulas of `slowlight/physics` and `slowlight/spectrum` for shaders in TSL (three.js), in 32-bit floats. c = 1,
 * lengths in metres, times in light-metres; u = γβ and γ of the observer are given as a pair, because f32 loses one
 * from the other. An `anchor` (d_c, R) is an event on the observer's past light cone (or slice of simultaneity): d_c
 * from the observer to it, R = |d_c|; places and times of vertices are relative to it (docs/physics.md §4.9).
 *
 * @module slowlight/shaders
 */

export { dopplerTint } from './color/dopplerTint.ts';
export { glowColor } from './color/glowColor.ts';
export { linearSpectrumShift, twoWavelengthShift } from './color/historicalShifts.ts';
export { toneMapAgx, toneMapLinear, toneMapNeutral } from './color/toneMap.ts';
export { hyperbolicEmission } from './emission/hyperbolicEmission.ts';
export { newtonEmission } from './emission/newtonEmission.ts';
export { ontoLightCone } from './emission/ontoLightCone.ts';
export { polylineEmission } from './emission/polylineEmission.ts';
export { staticEmission } from './emission/staticEmission.ts';
export { uniformEmission } from './emission/uniformEmission.ts';
export { aberrate } from './kinematics/aberrate.ts';
export { apparentPosition } from './kinematics/apparentPosition.ts';
export { boost } from './kinematics/boost.ts';
export { dopplerFactor } from './kinematics/dopplerFactor.ts';
export { emitterDoppler } from './kinematics/emitterDoppler.ts';
export { observerDoppler } from './kinematics/observerDoppler.ts';
export { simultaneousPosition } from './kinematics/simultaneousPosition.ts';
export { unaberrate } from './kinematics/unaberrate.ts';
export { hyperbolicSlice } from './simultaneity/hyperbolicSlice.ts';
export { newtonSlice } from './simultaneity/newtonSlice.ts';
export { polylineSlice } from './simultaneity/polylineSlice.ts';
export { uniformSlice } from './simultaneity/uniformSlice.ts';
export type { HalfTexels } from './tables/halfAtlas.ts';
export type {
  Bool,
  Float,
  HyperbolicVertexEvent,
  Int,
  SampleTable,
  Vec3,
  Vec4,
  VertexEvent,
  WorldLineAt,
} from './types.ts';
export { hyperbolicPlace } from './worldLines/hyperbolicPlace.ts';
export { polylinePlace } from './worldLines/polylinePlace.ts';
export { uniformPlace } from './worldLines/uniformPlace.ts';
