import { once } from 'node:events';
import { Command } from 'commander';
import { type Message, msg } from '../../messages/message.ts';
import { parsePort } from '../flags/parse.ts';
import { localized } from '../terminal/language.ts';
import { PortTaken, type RunningServer, serveApp } from './staticServer.ts';

const DEFAULT_PORT = 5510;

export const serveCommand = (): Command =>
  new Command('serve')
    .description(localized(msg`Serves the web page on this machine.`))
    .option(
      '--port <n>',
      localized(msg`port on 127.0.0.1; 0: any free port (default: ${DEFAULT_PORT}, or any if that is in use)`),
      parsePort,
    )
    .option('--json', localized(msg`print the address as JSON`))
    .action(serve);

async function serve(flags: { port?: number; json?: boolean }): Promise<void> {
  const server = await start(flags.port);
  console.log(flags.json ? JSON.stringify({ url: server.url }) : localized(welcome(server.url)));
  await Promise.race([once(process, 'SIGINT'), once(process, 'SIGTERM')]);
  await server.close();
}

/** Uses any free port if the default one is taken, so that a second instance starts too. */
async function start(port: number | undefined): Promise<RunningServer> {
  if (port !== undefined) return serveApp(port);
  try {
    return await serveApp(DEFAULT_PORT);
  } catch (error) {
    if (error instanceof PortTaken) return serveApp(0);
    throw error;
  }
}

const welcome = (url: string): Message => msg`
  Slowlight is at  ${url}

  Open it in a browser, pick a scene, then:
    W A S D Q E   accelerate          mouse drag  look around
    Shift         up to full speed    Tab         lock: free, look, fly
    Space         play, pause         ?           all keys

  Ctrl-C here stops it.`;
