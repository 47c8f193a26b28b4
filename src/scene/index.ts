/**
 * What is observed: objects, meshes, motions, materials, lights and cameras; the observer, the settings of a picture.
 * World frame, SI units.
 *
 * @module slowlight/scene
 */

export type { BoundingBox, BoundingSphere } from './bounds/bounds.ts';
export { boundingBox, boundingSphere } from './bounds/bounds.ts';
export { objectBounds, sceneBounds } from './bounds/sceneBounds.ts';
export { type Clock, type ClockCarrier, objectClocks } from './clocks/clock.ts';
export { type ClockAbsence, type ClockReading, type ClockReadings, readClock } from './clocks/readClock.ts';
export { FOREVER, IDENTITY_POSE, makeMaterial, makeObject, makeScene, restingAt } from './defaults.ts';
export type { DomeFilm, FilmLayout, FilmTrack } from './film/film.ts';
export { type FilmEvent, type FilmedDome, filmedDome } from './film/seenFilm.ts';
export { type Inspection, inspectEvent } from './inspection/inspectEvent.ts';
export { type MeasuredLengths, measureLengths } from './inspection/measureLengths.ts';
export { type SurfaceEvent, surfaceLine } from './inspection/surfaceLine.ts';
export { type BuiltMesh, makeMesh } from './mesh/makeMesh.ts';
export { mergeMeshes, transformMesh, withMaterial } from './mesh/meshOps.ts';
export type { Polygons, PolygonValues } from './mesh/polygons.ts';
export type { Axis, RadiusHeight, RoundOptions, SurfaceBand } from './mesh/primitives.ts';
export { box, capsule, cone, cylinder, grid, plane, revolve, sphere, torus } from './mesh/primitives.ts';
export { type Flight, fly } from './motion/fly.ts';
export type { FastestVertex } from './motion/kinds/motionKind.ts';
export {
  fastestVertex,
  originWorldLine,
  poseAt,
  vertexPosition,
  vertexPositions,
  vertexWorldLine,
} from './motion/motion.ts';
export { changeMotion, type MotionChange } from './motion/motionChange.ts';
export { retime, type Timing } from './motion/retime.ts';
export type { Solver } from './settings/settings.ts';
export type { Stars } from './stars/brightStars.ts';
export type { StoredFile } from './streaming/storedNumbers.ts';
export type * from './types.ts';
export { InputError } from './types.ts';
export { validate } from './validation/validate.ts';
export type { CameraState } from './view/camera.ts';
export { framingCamera, lookAtOrientation, observerFromCamera } from './view/camera.ts';
export type { CaptureSettings } from './view/capture.ts';
export type { CubeLayout, CubeLens } from './view/lenses/cubeLens.ts';
export type { EquirectangularLens } from './view/lenses/equirectangularLens.ts';
export { domeLens, type FisheyeLens } from './view/lenses/fisheyeLens.ts';
export type { Lens, PanoramicLens } from './view/lenses/lenses.ts';
export { type FrustumSides, offAxisLens, type PerspectiveLens, perspective } from './view/lenses/perspectiveLens.ts';
export type { StereoLens } from './view/lenses/stereoLens.ts';
export type { LightMeterReadings, MeteredQuantities } from './view/metering.ts';
export type { Orbit, OutsideCamera } from './view/outsideCamera.ts';
export { orbitCamera } from './view/outsideCamera.ts';
export type { PictureSize } from './view/pictureSize.ts';
export type { PictureView, PictureViews, PixelRect } from './view/pictureViews.ts';
export type { VertexProbe } from './view/probe.ts';
export { probeVertex, probeVertices } from './view/probe.ts';
export type {
  CubemapPicture,
  EquirectangularPicture,
  SphericalCrop,
  SphericalPicture,
  StereoLayout,
} from './view/sphericalPicture.ts';
export {
  AOVS,
  type AovInfo,
  type AovName,
  DEFAULT_SETTINGS,
  type RenderSettings,
  type ViewPoint,
} from './view/view.ts';
export type { ProbeObserver, ProbeOptions } from './views/viewRecord.ts';
export type { View } from './views/views.ts';
