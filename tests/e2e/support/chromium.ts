// How the tests start Debian's Chromium: headless, a fresh profile, nothing that calls home.
import type { LaunchOptions } from 'playwright-core';

/** The engine without the windows of a browser: the same pages in two thirds of the processor's time. */
export function chromiumOptions(extra: readonly string[] = []): LaunchOptions {
  return options(process.env['CHROMIUM_SHELL'] ?? '/usr/bin/chromium-headless-shell', extra);
}

/** The browser that a visitor has: for measurements, and for functions that only a whole browser has. */
export function wholeChromium(extra: readonly string[] = []): LaunchOptions {
  return options(process.env['CHROMIUM'] ?? '/usr/bin/chromium', extra);
}

function options(executablePath: string, extra: readonly string[]): LaunchOptions {
  return {
    executablePath,
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
export const SOFTWARE_WEB_GL: readonly string[] = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
