// How the tests start Debian's Chromium: headless, a fresh profile, nothing that calls home.
import type { LaunchOptions } from 'playwright-core';

export function chromiumOptions(extra: readonly string[] = []): LaunchOptions {
  return {
    executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
    headless: true,
    args: [
      '--no-sandbox',
      '--disable-gpu',
      '--disable-quic',
      '--no-first-run',
      '--disable-background-networking',
      '--disable-component-update',
      '--disable-sync',
      ...extra,
    ],
  };
}

/** Gives WebGL to a machine without a graphics card. */
export const kSoftwareWebGl: readonly string[] = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
