export { chainOf, nearestOf, outputIn } from './chain.ts';
export type { CameraView, GBuffer, Picture, Relativity } from './define.ts';
export { nodeLibrary } from './library.ts';
export { pictureOf, renderSettings } from './picture.ts';
export { flightsIn, flyCommand, landCommand, newProject, openCommand, setCommand } from './project.ts';
export { type OpenedProject, openProject, packProject } from './projectArchive.ts';
export type { FastestPoint, LoadedScene, ReadRequest, Services } from './services.ts';
