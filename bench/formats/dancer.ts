import { Document, WebIO } from '@gltf-transform/core';

const [MESHES, SIDE, JOINTS, FRAMES] = [60, 24, 20, 1300];
const FRAMES_PER_SECOND = 24;

/** The same as `dancer.usdc` of formats.py: sheets that follow a chain of joints along x, each turning. */
export async function dancerGlb(): Promise<Uint8Array> {
  const document = new Document();
  const buffer = document.createBuffer();
  const accessor = (type: 'SCALAR' | 'VEC3' | 'VEC4' | 'MAT4', array: Float32Array | Uint16Array) =>
    document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const scene = document.createScene();

  const joints = Array.from({ length: JOINTS }, (_, k) => document.createNode(`j${k}`));
  for (const [k, joint] of joints.entries()) {
    joint.setTranslation([k === 0 ? -1 : 2 / JOINTS, 0, 0]);
    if (k > 0) joints[k - 1].addChild(joint);
  }
  scene.addChild(joints[0]);
  const inverse = (k: number): number[] => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1 - (2 * k) / JOINTS, 0, 0, 1];
  const skin = document
    .createSkin()
    .setInverseBindMatrices(accessor('MAT4', Float32Array.from(joints.flatMap((_, k) => inverse(k)))));
  for (const joint of joints) skin.addJoint(joint);

  const times = Float32Array.from({ length: FRAMES }, (_, frame) => frame / FRAMES_PER_SECOND);
  const turns = new Float32Array(4 * FRAMES);
  for (let frame = 0; frame < FRAMES; frame++) {
    const half = 0.05 * Math.sin((2 * Math.PI * frame) / 100);
    turns.set([0, 0, Math.sin(half), Math.cos(half)], 4 * frame);
  }
  const sampler = document
    .createAnimationSampler()
    .setInput(accessor('SCALAR', times))
    .setOutput(accessor('VEC4', turns));
  const animation = document.createAnimation().addSampler(sampler);
  for (const joint of joints)
    animation.addChannel(
      document.createAnimationChannel().setTargetNode(joint).setTargetPath('rotation').setSampler(sampler),
    );

  for (let k = 0; k < MESHES; k++) {
    const { positions, followed, weights, corners } = sheet();
    const primitive = document
      .createPrimitive()
      .setAttribute('POSITION', accessor('VEC3', positions))
      .setAttribute('JOINTS_0', accessor('VEC4', followed))
      .setAttribute('WEIGHTS_0', accessor('VEC4', weights))
      .setIndices(accessor('SCALAR', corners));
    const mesh = document.createMesh(`Sheet${k}`).addPrimitive(primitive);
    scene.addChild(document.createNode(`Sheet${k}`).setMesh(mesh).setSkin(skin));
  }
  return new WebIO().writeBinary(document);
}

/** A wavy sheet; every vertex follows the two nearest joints. */
function sheet() {
  const positions = new Float32Array(3 * SIDE * SIDE);
  const followed = new Uint16Array(4 * SIDE * SIDE);
  const weights = new Float32Array(4 * SIDE * SIDE);
  for (let v = 0; v < SIDE * SIDE; v++) {
    const [x, y] = [v % SIDE, Math.floor(v / SIDE)].map((i) => (2 * i) / (SIDE - 1) - 1);
    positions.set([x, y, 0.1 * Math.sin(5 * x) * Math.cos(7 * y)], 3 * v);
    const along = ((x + 1) / 2) * JOINTS;
    const joint = Math.min(Math.floor(along), JOINTS - 2);
    const second = Math.min(along - joint, 1);
    followed.set([joint, joint + 1], 4 * v);
    weights.set([1 - second, second], 4 * v);
  }
  const corners: number[] = [];
  for (let y = 0; y < SIDE - 1; y++)
    for (let x = 0; x < SIDE - 1; x++) {
      const a = y * SIDE + x;
      corners.push(a, a + 1, a + SIDE + 1, a, a + SIDE + 1, a + SIDE);
    }
  return { positions, followed, weights, corners: Uint16Array.from(corners) };
}
