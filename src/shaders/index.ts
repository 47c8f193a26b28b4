export { aberrate } from './aberrate.ts';
export { apparentPosition } from './apparentPosition.ts';
export { boost } from './boost.ts';
export { cubicEmission } from './cubicEmission.ts';
export { cubicPlace } from './cubicPlace.ts';
export { cubicSlice } from './cubicSlice.ts';
export { dopplerFactor } from './dopplerFactor.ts';
export { dopplerTint } from './dopplerTint.ts';
export { emitterDoppler } from './emitterDoppler.ts';
export { glowColor } from './glowColor.ts';
export { HalfAtlas, type HalfTable, type HalfTexels } from './halfAtlas.ts';
export { hyperbolicEmission } from './hyperbolicEmission.ts';
export { hyperbolicPlace } from './hyperbolicPlace.ts';
export { hyperbolicSlice } from './hyperbolicSlice.ts';
export { lineColor } from './lineColor.ts';
export { newtonEmission } from './newtonEmission.ts';
export { observerDoppler } from './observerDoppler.ts';
export { observerTexels } from './observerTable.ts';
export { ontoLightCone } from './ontoLightCone.ts';
export { polylineEmission } from './polylineEmission.ts';
export { polylinePlace } from './polylinePlace.ts';
export { polylineSlice } from './polylineSlice.ts';
export { simultaneousPosition } from './simultaneousPosition.ts';
export { type SkyParts, skyParts } from './skyParts.ts';
export {
  type BandColors,
  coloredColors,
  filteredColor,
  luminanceOf,
  type SpectrumTable,
  spectrumTable,
  thermalColors,
} from './spectrumTable.ts';
export { staticEmission } from './staticEmission.ts';
export { toneMapAgx, toneMapLinear, toneMapNeutral } from './toneMap.ts';
export type { HyperbolicVertexEvent, SampleTable, VertexEvent, WorldLineAt } from './types.ts';
export { unaberrate } from './unaberrate.ts';
export { uniformEmission } from './uniformEmission.ts';
export { uniformPlace } from './uniformPlace.ts';
export { uniformSlice } from './uniformSlice.ts';
