/* What panoramic pictures are put together with; loaded by the first of them. */

export { FaceGatherer } from './faceGatherer.ts';
export { facesOf, faceViewPoint } from './pictureFaces.ts';
