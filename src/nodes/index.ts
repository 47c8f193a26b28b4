export { nodeLibrary } from './library.ts';
export { evaluatedPicture, renderSettings } from './pictures/renderSettings.ts';
export {
  nearestToOutput,
  nodesFeedingOutput,
  outputNodeId,
} from './project/outputChain.ts';
export {
  openProjectArchive,
  type ProjectArchive,
  packProjectArchive,
} from './project/projectArchive.ts';
export {
  flyCommand,
  flyNodesIn,
  newProject,
  openFileCommand,
  removeFlightCommand,
  setParamCommand,
} from './project/projectCommands.ts';
export type { FastestScenePoint, LoadedScene, ReadRequest, Services } from './services.ts';
export type {
  CameraView,
  GBufferSpec,
  PictureSpec,
  RelativisticScene,
} from './socketValues.ts';
