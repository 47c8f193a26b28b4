import type { Registry } from '../graph/nodeType.ts';
import { cameraNode } from './composition/camera.ts';
import { lampNode } from './composition/lamp.ts';
import { observerNode } from './composition/observer.ts';
import { panoramaNode } from './composition/panorama.ts';
import { relativityConsoleNode } from './composition/relativityConsole.ts';
import { sceneNode } from './composition/scene.ts';
import { skyNode } from './composition/sky.ts';
import { spectrumNode } from './composition/spectrum.ts';
import { sunNode } from './composition/sun.ts';
import { timeNode } from './composition/time.ts';
import { cacheNode } from './dynamics/cache.ts';
import { colliderNode } from './dynamics/collider.ts';
import { fieldNode } from './dynamics/field.ts';
import { massSpringNode } from './dynamics/massSpring.ts';
import { simulateNode } from './dynamics/simulate.ts';
import { flyNode } from './geometry/fly.ts';
import { instancesNode } from './geometry/instances.ts';
import { lifetimeNode } from './geometry/lifetime.ts';
import { materialNode } from './geometry/material.ts';
import { mergeNode } from './geometry/merge.ts';
import { moveNode } from './geometry/move.ts';
import { boxNode } from './geometry/primitives/box.ts';
import { cylinderNode } from './geometry/primitives/cylinder.ts';
import { gridNode } from './geometry/primitives/grid.ts';
import { latticeNode } from './geometry/primitives/lattice.ts';
import { solidTextNode } from './geometry/primitives/solidText.ts';
import { sphereNode } from './geometry/primitives/sphere.ts';
import { torusNode } from './geometry/primitives/torus.ts';
import { readNode } from './geometry/read.ts';
import { retimeNode } from './geometry/retime.ts';
import { subdivideNode } from './geometry/subdivide.ts';
import { textureNode } from './geometry/texture.ts';
import { transformNode } from './geometry/transform.ts';
import { writeUsdNode } from './geometry/writeUsd.ts';
import { circularNode } from './motion/circular.ts';
import { hyperbolicNode } from './motion/hyperbolic.ts';
import { keyframesNode } from './motion/keyframes.ts';
import { pathNode } from './motion/path.ts';
import { spinNode } from './motion/spin.ts';
import { uniformNode } from './motion/uniform.ts';
import { ambientOcclusionNode } from './render/ambientOcclusion.ts';
import { antialiasingNode } from './render/antialiasing.ts';
import { captureNode } from './render/capture.ts';
import { deferredLightingNode } from './render/deferredLighting.ts';
import { depthOfFieldNode } from './render/depthOfField.ts';
import { falseColorNode } from './render/falseColor.ts';
import { mixColorNode } from './render/mixColor.ts';
import { rasterizeNode } from './render/ordinaryRasterize.ts';
import { outputNode } from './render/output.ts';
import { outsideViewNode } from './render/outsideView.ts';
import { postProcessNode } from './render/postProcess.ts';
import { relativityRasterizeNode } from './render/relativityRasterize.ts';
import { saveImageNode } from './render/saveImage.ts';
import { saveVideoNode } from './render/saveVideo.ts';
import { sceneCameraNode } from './render/sceneCamera.ts';
import { stillNodes } from './render/still.ts';
import { toneMapNode } from './render/toneMap.ts';
import type { Services } from './services.ts';
import { colorNode } from './utility/color.ts';
import { compareNode } from './utility/compare.ts';
import { groupNode } from './utility/group.ts';
import { groupInputNode } from './utility/groupInput.ts';
import { groupOutputNode } from './utility/groupOutput.ts';
import { mathNode } from './utility/math.ts';
import { numberNode } from './utility/number.ts';
import { rerouteNode } from './utility/reroute.ts';
import { separateNode } from './utility/separate.ts';
import { switchNode } from './utility/switch.ts';
import { textNode } from './utility/text.ts';
import { vectorNode } from './utility/vector.ts';
import { vectorMathNode } from './utility/vectorMath.ts';

/** In menu order. */
const types = [
  readNode,
  boxNode,
  sphereNode,
  cylinderNode,
  torusNode,
  gridNode,
  latticeNode,
  solidTextNode,
  transformNode,
  instancesNode,
  materialNode,
  textureNode,
  subdivideNode,
  mergeNode,
  lifetimeNode,
  moveNode,
  uniformNode,
  hyperbolicNode,
  circularNode,
  spinNode,
  pathNode,
  keyframesNode,
  retimeNode,
  writeUsdNode,
  flyNode,
  massSpringNode,
  colliderNode,
  fieldNode,
  simulateNode,
  cacheNode,
  sceneNode,
  sunNode,
  lampNode,
  skyNode,
  panoramaNode,
  spectrumNode,
  cameraNode,
  observerNode,
  timeNode,
  relativityConsoleNode,
  sceneCameraNode,
  outsideViewNode,
  captureNode,
  relativityRasterizeNode,
  rasterizeNode,
  ...stillNodes,
  deferredLightingNode,
  ambientOcclusionNode,
  postProcessNode,
  depthOfFieldNode,
  antialiasingNode,
  mixColorNode,
  toneMapNode,
  falseColorNode,
  outputNode,
  saveImageNode,
  saveVideoNode,
  numberNode,
  vectorNode,
  separateNode,
  colorNode,
  textNode,
  mathNode,
  vectorMathNode,
  compareNode,
  switchNode,
  rerouteNode,
  groupNode,
  groupInputNode,
  groupOutputNode,
];

/**
 * All node types by id; a new type is registered only here.
 * @example
 * nodeLibrary.fly.category; // 'geometry'
 */
export const nodeLibrary: Registry<Services> = Object.fromEntries(types.map((type) => [type.id, type]));
