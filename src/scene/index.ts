export type { Box, Sphere } from './bounds.ts';
export { boundingBox, boundingSphere, emissionWindow, objectBounds, sceneBounds } from './bounds.ts';
export type { CameraView } from './camera.ts';
export { framingCamera, lookAtOrientation, observerFromCamera } from './camera.ts';
export { changeMotion, type MotionChange } from './change.ts';
export { FOREVER, makeMaterial, makeObject, makeScene, ORIGIN, restingAt } from './defaults.ts';
export type { FastestPoint } from './fastest.ts';
export { fastest } from './fastest.ts';
export { type Flight, fly } from './fly.ts';
export type { BuiltMesh } from './geometry.ts';
export { gatherPoints, makeMesh } from './geometry.ts';
export { mergeMeshes, transformMesh, withMaterial } from './meshOps.ts';
export {
  bornRigidAcceleration,
  originLine,
  poseAt,
  samplePose,
  vertexPosition,
  vertexPositions,
  vertexWorldLine,
} from './motion.ts';
export { cornerNormals, deformedNormals, smoothingGroups } from './normals.ts';
export type { Polygons, PolygonValues } from './polygons.ts';
export type { Axis, Band, RoundOptions } from './primitives.ts';
export { box, capsule, cone, cylinder, grid, plane, revolve, sphere, torus } from './primitives.ts';
export type { ProbeObserver, VertexProbe } from './probe.ts';
export { probeVertex, probeVertices } from './probe.ts';
export type { Samples } from './resample.ts';
export { resampleRotation, restToWorld, sampleMotion } from './resample.ts';
export { retime, type Timing } from './retime.ts';
export type * from './types.ts';
export { InputError } from './types.ts';
export { validate } from './validate.ts';
export {
  AOVS,
  type AovInfo,
  type AovName,
  DEFAULT_SETTINGS,
  type RenderSettings,
  type Solver,
  type View,
  type ViewPoint,
} from './view.ts';
