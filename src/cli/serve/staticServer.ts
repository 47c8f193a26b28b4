import { createReadStream, statSync } from 'node:fs';
import { createServer, type IncomingMessage, type Server, type ServerResponse } from 'node:http';
import { type AddressInfo, isIP } from 'node:net';
import { extname, join, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { msg } from '../../messages/message.ts';
import { messageOf } from '../../messages/messageError.ts';
import { CliError, EXIT, unavailable } from '../terminal/exitCodes.ts';

const packageRoot = fileURLToPath(new URL('../../../../', import.meta.url));
export const appFolder = join(packageRoot, 'dist', 'app');
/** The pages of the library's API, at /api/. */
const apiFolder = join(packageRoot, 'dist', 'api');
const API = '/api/';
const NO_API_PAGES = 'these pages are being made, or are to be made: npm run build -- api';

/** Only the page's own scripts may run. */
const contentPolicy =
  "default-src 'self'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' blob: data:; worker-src 'self' blob:; object-src 'none'; base-uri 'none'; frame-ancestors 'none'";

const mimeTypes: Readonly<Record<string, string>> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json; charset=utf-8',
  '.webmanifest': 'application/manifest+json; charset=utf-8',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.jpg': 'image/jpeg',
  '.webp': 'image/webp',
  '.ico': 'image/x-icon',
  '.woff2': 'font/woff2',
  '.wasm': 'application/wasm',
  '.map': 'application/json; charset=utf-8',
  '.md': 'text/markdown; charset=utf-8',
  '.usda': 'text/plain; charset=utf-8',
  '.usdz': 'model/vnd.usdz+zip',
  '.gltf': 'model/gltf+json',
  '.glb': 'model/gltf-binary',
};

/** Serves paths that are not files of the page; undefined for 404. */
export type ExtraFiles = (path: string) => Promise<Uint8Array | undefined>;

export interface RunningServer {
  readonly url: string;
  close(): Promise<void>;
}

/** Serves the built page on 127.0.0.1. Port 0: any free port. */
export async function serveApp(port: number, extra?: ExtraFiles): Promise<RunningServer> {
  if (!isFile(join(appFolder, 'index.html'))) {
    throw unavailable(
      msg`the page is not built. Run \`npm run build\` in the project folder (or \`npm start\`, which does it all)`,
    );
  }
  const server = createServer((request, response) => {
    answer(request, response, extra).catch(() => refuse(response, 500));
  });
  await listen(server, port);
  const url = `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
  const close = (): Promise<void> =>
    new Promise((done) => {
      server.close(() => done());
      server.closeAllConnections();
    });
  return { url, close };
}

export class PortTaken extends CliError {
  constructor(port: number) {
    super(EXIT.unavailable, msg`port ${port} is in use; choose another with --port, or stop what uses it`);
  }
}

function listen(server: Server, port: number): Promise<void> {
  return new Promise((resolve, reject) => {
    server.once('error', (error: NodeJS.ErrnoException) => {
      reject(error.code === 'EADDRINUSE' ? new PortTaken(port) : unavailable(messageOf(error)));
    });
    server.listen(port, '127.0.0.1', resolve);
  });
}

async function answer(request: IncomingMessage, response: ServerResponse, extra?: ExtraFiles): Promise<void> {
  if (request.method !== 'GET' && request.method !== 'HEAD') return refuse(response, 405);
  // Against DNS rebinding: another site's name may resolve to 127.0.0.1 and then read this server as its own origin.
  if (!isLoopbackName(request.headers.host)) return refuse(response, 403);
  const path = decodePath(request.url ?? '/');
  if (path === undefined) return refuse(response, 400);
  if (`${path}/` === API) return void response.writeHead(301, { Location: API }).end();
  const [folder, inside] = path.startsWith(API) ? [apiFolder, path.slice(API.length - 1)] : [appFolder, path];
  const file = join(folder, inside.endsWith('/') ? `${inside}index.html` : inside);
  if (file.startsWith(folder + sep) && isFile(file)) return sendFile(file, request, response);
  if (path === API) return refuse(response, 503, NO_API_PAGES);
  const bytes = await extra?.(path);
  if (!bytes) return refuse(response, 404);
  response.writeHead(200, { ...headers(path), 'Content-Length': bytes.length }).end(bytes);
}

function isLoopbackName(host: string | undefined): boolean {
  const name = (host ?? '').replace(/:\d+$/, '');
  return name === 'localhost' || name === '[::1]' || (isIP(name) === 4 && name.startsWith('127.'));
}

function decodePath(url: string): string | undefined {
  try {
    const path = decodeURIComponent(url.replace(/[?#].*$/s, ''));
    return path.includes('\0') ? undefined : path;
  } catch {
    return undefined;
  }
}

function isFile(path: string): boolean {
  return statSync(path, { throwIfNoEntry: false })?.isFile() ?? false;
}

function headers(path: string): Record<string, string> {
  return {
    'Content-Type': mimeTypes[extname(path).toLowerCase()] ?? 'application/octet-stream',
    'Content-Security-Policy': contentPolicy,
    'X-Content-Type-Options': 'nosniff',
    'Referrer-Policy': 'no-referrer',
    // Names of the page's assets contain a hash of their content.
    'Cache-Control': path.startsWith(join(appFolder, 'assets') + sep)
      ? 'public, max-age=31536000, immutable'
      : 'no-cache',
  };
}

function sendFile(file: string, request: IncomingMessage, response: ServerResponse): void {
  response.writeHead(200, { ...headers(file), 'Content-Length': statSync(file).size });
  if (request.method === 'HEAD') response.end();
  else
    createReadStream(file)
      .on('error', () => response.destroy())
      .pipe(response);
}

function refuse(response: ServerResponse, status: number, why = ''): void {
  if (response.headersSent) response.destroy();
  else response.writeHead(status, { 'Content-Type': 'text/plain' }).end(`${status} ${why}\n`);
}
