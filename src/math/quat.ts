/** A quaternion x i + y j + z k + w; unit where it stands for a rotation. */
export type Quat = readonly [x: number, y: number, z: number, w: number];
