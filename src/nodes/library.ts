import type { Registry } from '../graph/nodeType.ts';
import { cameraNode } from './composition/cameraAt.ts';
import { relativityConsole } from './composition/console.ts';
import { lampNode } from './composition/lamp.ts';
import { observerNode } from './composition/observer.ts';
import { scene } from './composition/scene.ts';
import { skyNode } from './composition/sky.ts';
import { spectrumNode } from './composition/spectrum.ts';
import { sunNode } from './composition/sun.ts';
import { timeNode } from './composition/time.ts';
import { cacheNode } from './dynamics/cache.ts';
import { colliderNode } from './dynamics/collider.ts';
import { fieldNode } from './dynamics/field.ts';
import { massSpringNode } from './dynamics/massSpring.ts';
import { simulateNode } from './dynamics/simulate.ts';
import { boxNode } from './geometry/box.ts';
import { cylinderNode } from './geometry/cylinder.ts';
import { flyNode } from './geometry/fly.ts';
import { gridNode } from './geometry/grid.ts';
import { instancesNode } from './geometry/instances.ts';
import { latticeNode } from './geometry/lattice.ts';
import { lifetimeNode } from './geometry/lifetime.ts';
import { materialNode } from './geometry/material.ts';
import { mergeNode } from './geometry/merge.ts';
import { moveNode } from './geometry/move.ts';
import { read } from './geometry/read.ts';
import { retimeNode } from './geometry/retime.ts';
import { solidTextNode } from './geometry/solidText.ts';
import { sphereNode } from './geometry/sphere.ts';
import { subdivideNode } from './geometry/subdivide.ts';
import { torusNode } from './geometry/torus.ts';
import { transformNode } from './geometry/transform.ts';
import { writeUsdNode } from './geometry/writeUsd.ts';
import { circularNode } from './motion/circular.ts';
import { hyperbolicNode } from './motion/hyperbolic.ts';
import { keyframesNode } from './motion/keyframes.ts';
import { pathNode } from './motion/path.ts';
import { spinNode } from './motion/spin.ts';
import { uniformNode } from './motion/uniform.ts';
import { antialiasing } from './render/antialiasing.ts';
import { sceneCamera } from './render/camera.ts';
import { depthOfField } from './render/depthOfField.ts';
import { falseColour } from './render/falseColour.ts';
import { deferredLighting } from './render/lighting.ts';
import { mixColor } from './render/mixColor.ts';
import { ambientOcclusion } from './render/occlusion.ts';
import { output } from './render/output.ts';
import { postProcess } from './render/postProcess.ts';
import { relativityRasterize } from './render/rasterize.ts';
import { rasterize } from './render/rasterizeOrdinary.ts';
import { referenceRender } from './render/referenceRender.ts';
import { saveImageNode } from './render/saveImage.ts';
import { saveVideoNode } from './render/saveVideo.ts';
import { toneMap } from './render/toneMap.ts';
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

/** In the order in which menus show them. */
const types = [
  read,
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
  scene,
  sunNode,
  lampNode,
  skyNode,
  spectrumNode,
  cameraNode,
  observerNode,
  timeNode,
  relativityConsole,
  sceneCamera,
  relativityRasterize,
  rasterize,
  referenceRender,
  deferredLighting,
  ambientOcclusion,
  postProcess,
  depthOfField,
  antialiasing,
  mixColor,
  toneMap,
  falseColour,
  output,
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

/** Every node type, by id: a new one is added here and nowhere else. */
export const nodeLibrary: Registry<Services> = Object.fromEntries(types.map((type) => [type.id, type]));
