/**
 * The nodes of Slowlight's projects, and edits of whole projects.
 *
 * @module slowlight/nodes
 */

export { nodeLibrary } from './library.ts';
export { evaluatedPicture, type FalseColorScales, renderSettings } from './pictures/renderSettings.ts';
export { outputNodeId } from './project/outputChain.ts';
export { openProjectArchive, type ProjectArchive, packProjectArchive } from './project/projectArchive.ts';
export { flyCommand, newProject, openFileCommand, setParamCommand } from './project/projectCommands.ts';
export type { FastestScenePoint, LoadedScene, ReadRequest, Services } from './services.ts';
export type { CameraView, GBufferSpec, ImageSpec, PictureSpec, RelativisticScene } from './socketValues.ts';
