import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync, realpathSync } from 'node:fs';
import { homedir } from 'node:os';
import { delimiter, dirname, join } from 'node:path';

const manifestFolders = [
  '/usr/share/vulkan/icd.d',
  '/usr/local/share/vulkan/icd.d',
  '/etc/vulkan/icd.d',
  join(homedir(), '.local/share/vulkan/icd.d'),
];

/** Whether the Vulkan loader will find a driver; without one it prints warnings. */
export function hasVulkanDriver(): boolean {
  if (process.platform !== 'linux' || process.env.VK_ICD_FILENAMES || process.env.VK_DRIVER_FILES) return true;
  return manifestFolders.some((folder) => existsSync(folder) && readdirSync(folder).some((f) => f.endsWith('.json')));
}

/** Path of Chromium or a browser based on it: `CHROMIUM`, else the first one on the PATH. */
export function findChromium(): string | undefined {
  if (process.env.CHROMIUM) return process.env.CHROMIUM;
  const folders = (process.env.PATH ?? '').split(delimiter);
  const names = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable'];
  return names.flatMap((name) => folders.map((folder) => join(folder, name))).find((path) => existsSync(path));
}

/** Path of the ICD file of Chromium's SwiftShader, a software Vulkan driver; undefined if not installed. */
export function findSwiftShader(): string | undefined {
  const name = 'vk_swiftshader_icd.json';
  const chromium = findChromium();
  const beside = chromium && existsSync(chromium) ? [join(dirname(realpathSync(chromium)), name)] : [];
  const usual = ['/usr/lib/chromium', '/usr/lib/chromium-browser', '/opt/google/chrome'].map((f) => join(f, name));
  return [...beside, ...usual].find((path) => existsSync(path)) ?? askDpkg(name);
}

function askDpkg(name: string): string | undefined {
  const { stdout } = spawnSync('dpkg', ['-L', 'chromium-common'], { encoding: 'utf8' });
  return stdout?.split('\n').find((line) => line.endsWith(name));
}

/** Chromium's flags for tests and benchmarks: without a GPU, WebGPU on SwiftShader and WebGL2 on Mesa's llvmpipe. */
export const SOFTWARE_GPU_FLAGS: readonly string[] = [
  '--no-sandbox',
  '--enable-unsafe-webgpu',
  '--use-webgpu-adapter=swiftshader',
  '--use-gl=angle',
  '--use-angle=gl-egl',
  '--ignore-gpu-blocklist',
];
