/** The codes of `validate`, which are independent of the scene's format, and their meanings. */
export const SCENE_CODES = {
  'scene.duplicate-path': 'two objects have one path',
  'mesh.empty': 'a mesh without triangles',
  'mesh.index': 'a triangle names a vertex that is not there',
  'mesh.length': 'normals or uvs that are not as many as the vertices',
  'mesh.material': 'a mesh wears a material that is not there',
  'mesh.degenerate': 'triangles without an area',
  'mesh.not-finite': 'a vertex is nowhere: NaN or infinite',
  'motion.samples': 'samples whose number is not that of their times',
  'motion.times': 'times that do not increase, or are none',
  'motion.rest-points': 'a deforming body that is authored at rest, which nothing says how to contract',
  'motion.not-finite': 'a pose or velocity that is NaN or infinite',
  'motion.cubic': 'a cubic path that could be faster than light: it is shown straighter there',
  'motion.superluminal': 'something moves faster than light',
  'motion.horizon': 'part of an accelerated body lies beyond its horizon, where nothing can keep up with it',
  'object.lifetime': 'an object that dies before it is born',
  'light.size': 'a lamp whose size is negative or none',
  'light.color': 'a lamp whose colour is negative or none',
} as const;

export type SceneCode = keyof typeof SCENE_CODES;
