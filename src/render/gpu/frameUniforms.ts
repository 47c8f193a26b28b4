import { uniform } from 'three/tsl';
import { Matrix3, Vector2, Vector3 } from 'three/webgpu';

/** What every pass of a picture reads; `value` is written once per picture. */
export function makeFrameUniforms() {
  return {
    /** γβ and γ of the observer. */
    u: uniform(new Vector3()),
    gamma: uniform(1),
    iterations: uniform(1, 'int'),
    damping: uniform(1),
    /** 1 where what is seen are events on the past light cone. */
    onLightCone: uniform(1),
    /** 1 where directions are boosted, 0 where they are the world's. */
    boosted: uniform(1),
    /** 1 where light meets surfaces in their rest frame, 0 in the views that show no light. */
    boostLight: uniform(1),
    /** 1 where light takes its time from lamps to surfaces; 0 in pictures of one moment. */
    lightTravels: uniform(1),
    /** 1 where colours and brightness follow D; 0 in the views that show no light. */
    dopplerMix: uniform(1),
    beaming: uniform(1),
    exposure: uniform(0),
    /** 1/c */
    secondsPerMetre: uniform(0),
    /** Half the width and height of the picture at distance 1, and where its centre is there (`Frustum` of scene/view/lens.ts). */
    halfTangents: uniform(new Vector2(1, 1)),
    frustumCenter: uniform(new Vector2()),
    /** This sample's shift in the picture, in half-pictures. */
    jitter: uniform(new Vector2()),
    /** Camera axes → world axes carried by the boost. */
    orientation: uniform(new Matrix3()),
    /** Unit, world frame. */
    zenith: uniform(new Vector3(0, 1, 0)),
    /** Height of the observer above the ground [m], and its place along the ground's two axes, modulo the grid's coarsest step. */
    ground: uniform(new Vector3()),
    gridStep: uniform(1),
    gridEast: uniform(new Vector3(1, 0, 0)),
    gridNorth: uniform(new Vector3(0, 0, 1)),
    /** Share of the new sample in the accumulated picture. */
    weight: uniform(1),
    firstSample: uniform(1),
  };
}

export type FrameUniforms = ReturnType<typeof makeFrameUniforms>;
