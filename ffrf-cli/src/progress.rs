//! Progress of a long computation on standard error: a bar on a terminal, else a line every few seconds.

use std::io::IsTerminal;
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use ffrf_fe::modes::Progress;
use indicatif::{ProgressBar, ProgressStyle};

use crate::output;

/// How often a line is printed where there is no terminal.
const INTERVAL: Duration = Duration::from_secs(5);

/// Tells the progress until it is dropped.
pub enum Teller {
    /// A bar that is drawn over and over.
    Bar(ProgressBar),
    /// Lines of a thread of its own: one stage may take long without a word.
    Lines(Lines),
}

impl Teller {
    /// A bar if standard error is a terminal, else lines.
    pub fn new() -> Self {
        if std::io::stderr().is_terminal() {
            Self::Bar(bar())
        } else {
            Self::Lines(Lines::new(INTERVAL, |line| output::complain(&line)))
        }
    }

    /// Takes note of the state of the computation.
    pub fn tell(&self, progress: Progress) {
        match self {
            Self::Bar(bar) => {
                bar.set_message(progress.stage.to_string());
                bar.set_length(progress.total as u64);
                bar.set_position(progress.done as u64);
            }
            Self::Lines(lines) => lines.tell(progress),
        }
    }
}

impl Drop for Teller {
    fn drop(&mut self) {
        if let Self::Bar(bar) = self {
            bar.finish_and_clear();
        }
    }
}

fn bar() -> ProgressBar {
    let bar = ProgressBar::new(0);
    let style = ProgressStyle::with_template("{spinner} modes: {msg} [{bar:30}] {pos}/{len} {elapsed}");
    // The template is constant; should it ever be wrong, the plain bar serves.
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}

/// The thread that prints the lines.
pub struct Lines {
    sender: Option<Sender<Progress>>,
    thread: Option<JoinHandle<()>>,
}

impl Lines {
    fn new(interval: Duration, print: impl Fn(String) + Send + 'static) -> Self {
        let (sender, receiver) = mpsc::channel::<Progress>();
        let thread = thread::spawn(move || {
            let start = Instant::now();
            let mut next = start + interval;
            let mut latest = None;
            loop {
                match receiver.recv_timeout(next.saturating_duration_since(Instant::now())) {
                    Ok(progress) => latest = Some(progress),
                    Err(RecvTimeoutError::Disconnected) => return,
                    Err(RecvTimeoutError::Timeout) => {
                        if let Some(Progress { stage, done, total }) = latest {
                            let seconds = start.elapsed().as_secs();
                            print(format!("modes: {stage} {done}/{total} ({seconds} s)\n"));
                        }
                        next += interval;
                    }
                }
            }
        });
        Self { sender: Some(sender), thread: Some(thread) }
    }

    fn tell(&self, progress: Progress) {
        if let Some(sender) = &self.sender {
            // The thread listens as long as there is a sender.
            let _ = sender.send(progress);
        }
    }
}

impl Drop for Lines {
    fn drop(&mut self) {
        self.sender = None;
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

/// Progress of work whose share that is done is known.
pub struct ShareTeller {
    name: &'static str,
    bar: Option<ProgressBar>,
    last: std::cell::Cell<Instant>,
}

impl ShareTeller {
    /// A bar if standard error is a terminal, else a line every few seconds. `name`: what stands before it.
    pub fn new(name: &'static str) -> Self {
        let bar = std::io::stderr().is_terminal().then(|| {
            let bar = ProgressBar::new(1000);
            let style = ProgressStyle::with_template("{prefix} [{bar:40}] {percent} % {msg} {elapsed}");
            bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
            bar.with_prefix(name)
        });
        Self { name, bar, last: std::cell::Cell::new(Instant::now()) }
    }

    /// Takes note of where the work is.
    pub fn tell(&self, share: f64, message: &str) {
        match &self.bar {
            Some(bar) => {
                bar.set_message(message.to_owned());
                bar.set_position((1000.0 * share) as u64);
            }
            None if self.last.get().elapsed() >= INTERVAL => {
                self.last.set(Instant::now());
                output::complain(&format!("{}: {message} ({:.0} %)\n", self.name, 100.0 * share));
            }
            None => {}
        }
    }

    /// Takes the bar away.
    pub fn end(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::{Arc, Mutex};

    use ffrf_fe::modes::Stage;

    use super::*;

    fn lines(interval: Duration, work: Duration) -> Vec<String> {
        let printed = Arc::new(Mutex::new(Vec::new()));
        let sink = Arc::clone(&printed);
        let lines = Lines::new(interval, move |line| sink.lock().unwrap().push(line));
        lines.tell(Progress { stage: Stage::Factorising, done: 0, total: 1 });
        thread::sleep(work);
        drop(lines);
        Arc::try_unwrap(printed).unwrap().into_inner().unwrap()
    }

    #[test]
    fn a_long_stage_is_told_of_again_and_again_and_a_short_one_never() {
        let long = lines(Duration::from_millis(20), Duration::from_millis(200));
        assert!(long.len() > 1, "{long:?}");
        assert_eq!(long[0], format!("modes: {} 0/1 (0 s)\n", Stage::Factorising));
        assert!(lines(Duration::from_secs(60), Duration::ZERO).is_empty());
    }
}
