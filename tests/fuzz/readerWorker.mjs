// Reads files in a worker thread with the built library, so that a hanging reader can be terminated and reported.
import { parentPort, workerData } from 'node:worker_threads';

const { decodeImage, memorySource, openScene, readExr } = await import(`${workerData.library}formats/index.js`);
const { inEnglish } = await import(`${workerData.library}messages/index.js`);

let files = {};
let entry = '';
let opened = '';
parentPort.on('message', async (message) => {
  if (message.files) {
    ({ files, entry, opened } = message);
    return;
  }
  const began = performance.now();
  const outcome = await read(message.bytes);
  parentPort.postMessage({ ...outcome, milliseconds: performance.now() - began });
});
parentPort.postMessage({ ready: true });

async function read(bytes) {
  try {
    if (entry.endsWith('.exr')) readExr(bytes, entry);
    else if (/\.(png|jpg)$/.test(entry)) decodeImage(bytes, entry);
    else return ofScene(await openScene(memorySource({ ...files, [entry]: bytes }), opened, { openFilm }));
    return {};
  } catch (error) {
    if (error.name !== 'InputError' || !isSaid(error.diagnostic)) return { fault: `threw ${error.stack ?? error}` };
    return { refusal: error.message, said: error.diagnostic.code };
  }
}

/** Of films the containers are read here, not the pictures. */
const openFilm = ({ width, height }) => ({
  frame: async () => ({ width, height, data: new Uint8Array(4 * width * height) }),
  close: () => {},
});

const UNREAD = ['usd.unreadable-layer', 'file.unreadable-texture'];

/** Whether place and message are words, and no value of theirs was put into a string as an object. */
const isSaid = ({ place, message }) =>
  [place, message].map(inEnglish).every((words) => words !== '' && !words.includes('[object'));

function ofScene(scene) {
  const polluted = 'polluted' in {} ? 'every object is polluted' : undefined;
  const unsaid = scene.diagnostics.find((diagnostic) => !isSaid(diagnostic));
  if (unsaid) return { fault: `no words for users: ${JSON.stringify(unsaid)}` };
  // What is opened goes without a file beside it.
  const unread = opened !== entry && scene.diagnostics.find(({ code }) => UNREAD.includes(code));
  if (unread) return { refusal: inEnglish(unread.message), said: unread.code, fault: polluted };
  const objects = scene.objects.length;
  return { fault: polluted ?? faultOf(scene), objects, said: scene.diagnostics.map(({ code }) => code).join(' ') };
}

/** What is invalid in a scene; undefined where nothing is. */
function faultOf(scene) {
  for (const { path, mesh, motion } of scene.objects) {
    const vertices = mesh.positions.length / 3;
    if (mesh.indices.some((index) => index >= vertices)) return `${path} has a triangle without a corner`;
    if (!mesh.positions.every(Number.isFinite)) return `${path} has a point nowhere`;
    if (!mesh.normals.every(Number.isFinite)) return `${path} has no normal somewhere`;
    if (!mesh.uvs.every(Number.isFinite)) return `${path} has a uv nowhere`;
    if (mesh.groups.some(({ material }) => !(material < scene.materials.length))) return `${path} has no material`;
    const numbers = [motion.pose?.position, motion.pose?.orientation, motion.velocity, motion.poses, motion.times];
    if (numbers.some((list) => list && !list.every(Number.isFinite))) return `${path} moves nowhere`;
    if (motion.times?.some((time, i) => i > 0 && !(time > motion.times[i - 1]))) return `${path} has no order in time`;
    if (Array.isArray(motion.points) && motion.points.some((points) => !points.every(Number.isFinite)))
      return `${path} has points that move nowhere`;
  }
  if (!Number.isFinite(scene.startTime) || !Number.isFinite(scene.endTime)) return 'it begins or ends at no time';
  return undefined;
}
