export type { CameraView, GBuffer, Picture, Relativity } from './define.ts';
export { nodeLibrary } from './library.ts';
export { pictureOf, renderSettings } from './picture.ts';
export { newProject, openCommand } from './project.ts';
export type { FastestPoint, LoadedScene, Services } from './services.ts';
